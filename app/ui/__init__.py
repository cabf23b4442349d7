"""The window: widgets that listen to the session and push new studies."""
